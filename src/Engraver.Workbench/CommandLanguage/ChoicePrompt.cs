using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for one of the options and nothing else.</summary>
public sealed record ChoicePrompt(string Instruction) : ValuePrompt<string>(Instruction)
{
    public override bool OnlyOptions => true;

    public override ParsedInput<string> Parse(string typed, Point2D lastPoint) =>
        new ParsedInput<string>.Invalid(Wording.Get("ChoicePrompt.NotAnOption", typed, string.Join(", ", Options.Select(option => option.Shown))));
}
