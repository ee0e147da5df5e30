using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a word or a file name. Where spaces end an answer (a script), double quotes hold it together.</summary>
public sealed record TextPrompt(string Instruction) : ValuePrompt<string>(Instruction)
{
    /// <summary>Says why a text is no answer, so that it is asked for once more and nothing answered before is lost; null where it is one. Without this every text is an answer.</summary>
    public Func<string, string?>? Refusal { get; init; }

    public override bool TakesSpaces => true;

    public override Reading<string> Read(string typed, Point2D lastPoint) => Refusal?.Invoke(typed) is { } why ? new Reading<string>.Wrong(why) : new Reading<string>.Value(typed);
}
