using Engraver.TestKit;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>Like <see cref="CorpusTheoryAttribute"/>, for a test without data.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class CorpusFactAttribute : FactAttribute
{
    public CorpusFactAttribute()
    {
        if (RepositoryFolder.Corpus is null) Skip = "The corpus does not stand beside the project.";
    }
}
