using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>A test on the corpus of real drawings beside the project; skipped, visibly, where that is not laid out. In CI a skip is a failure.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class CorpusFactAttribute : FactAttribute
{
    public CorpusFactAttribute()
    {
        if (RepositoryFolder.Corpus is null) Skip = "The corpus does not stand beside the project.";
    }
}
