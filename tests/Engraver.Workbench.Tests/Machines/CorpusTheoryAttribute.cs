using Engraver.TestKit;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>A test on drawings of the corpus beside the project; skipped if the corpus is missing. In CI a skip is a failure.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class CorpusTheoryAttribute : TheoryAttribute
{
    public CorpusTheoryAttribute()
    {
        if (RepositoryFolder.Corpus is null) Skip = "The corpus does not stand beside the project.";
    }
}
