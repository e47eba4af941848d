/*!
\class SpiderVisitor "" ""
\ingroup PkgSpiderConcepts

What long work tells how far it is, for the parameter `visitor` of the functions over many points. It is copied, unless given by
`std::ref()`.

\cgalConcept
*/
class SpiderVisitor
{
public:
  /*!
  is called now and then, always from the thread that the work was called from: to show progress, or to cancel. What it throws
  comes out of the function; what has been stored by then stays.
  \param share how much of the work is done, from 0 to 1; never less than before, and 1 in the end
  */
  void progress(double share);
};
