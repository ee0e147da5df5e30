using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts;

/// <summary>Receives from a reader the differences between its program and the job; keeps the first one.</summary>
public sealed class RequirementsJudge(ProgramRequirements asked)
{
    public ProgramRequirements Required => asked;

    /// <summary>The first difference; null while there is none.</summary>
    public Diagnostic? Finding { get; private set; }

    /// <param name="line">Line of the program's text.</param>
    /// <param name="said">Actual value, in the words of the program.</param>
    /// <param name="expected">Required value, in the same words.</param>
    public void AddDifference(int line, string said, string expected) => Finding ??= VerificationRules.OtherThanAsked.At(new SourceRef(line), said, FactText.Of(line), expected);
}
