using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts;

/// <summary>What a job asks of its program beside the way and the settings of the machine: what the user of the post may choose and what no drawing tells. The defaults are those of the posts.</summary>
public sealed record ProgramTerms
{
    public static ProgramTerms Default { get; } = new();

    /// <summary>G-code in which every place counts: G54 to G59.</summary>
    public string WorkOffset { get; init; } = "G54";

    /// <summary>G-code that switches the tool where no axis holds it: m3, m8 or m64.</summary>
    public string ToolSwitch { get; init; } = "m3";

    /// <summary>S of G-code: of the spindle, or of what M3 switches.</summary>
    public double SpindleSpeed { get; init; } = 1000.0;

    /// <summary>Pen of HP-GL, 1 to 8.</summary>
    public int Pen { get; init; } = 1;
}

/// <summary>Told by a reader what its program does otherwise than the job asks; keeps the first of it.</summary>
public sealed class TermsJudge(ProgramTerms asked)
{
    public ProgramTerms Asked => asked;

    /// <summary>Null while everything is as asked.</summary>
    public Diagnostic? Finding { get; private set; }

    /// <param name="line">Of the program's text.</param>
    /// <param name="said">In the words of the program.</param>
    /// <param name="expected">In the same words.</param>
    public void Differ(int line, string said, string expected) => Finding ??= VerificationRules.OtherThanAsked.At(new SourceRef(line), said, FactText.Of(line), expected);
}
