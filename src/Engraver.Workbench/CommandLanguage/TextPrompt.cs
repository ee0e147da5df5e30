using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a word or a file name. If spaces end an answer (in a script), double quotes keep it together.</summary>
public sealed record TextPrompt(string Instruction) : ValuePrompt<string>(Instruction)
{
    public override bool AllowsSpaces => true;

    public override ParsedInput<string> Parse(string typed, Point2D lastPoint) => new ParsedInput<string>.Value(typed);
}
