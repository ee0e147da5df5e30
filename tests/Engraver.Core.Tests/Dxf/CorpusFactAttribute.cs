using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>A test on the corpus of real drawings beside the project; reported as skipped if the corpus is missing. In CI a skip is a failure.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class CorpusFactAttribute : FactAttribute
{
    public CorpusFactAttribute()
    {
        if (RepositoryFolder.Corpus is null) Skip = "The corpus does not stand beside the project.";
    }
}
