using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a word or a file name. If spaces end an answer (in a script), double quotes keep it together.</summary>
public sealed record TextPrompt(string Instruction) : ValuePrompt<string>(Instruction)
{
    public override bool AllowsSpaces => true;

    /// <summary>The command line begins with the default, to be edited.</summary>
    public bool EditsDefault { get; init; }

    /// <summary>Preview for a typed line that is not yet entered, drawing units; null without a preview.</summary>
    public Func<string, IReadOnlyList<Segment>>? TypedGhost { get; init; }

    public override ParsedInput<string> Parse(string typed, Point2D lastPoint) => new ParsedInput<string>.Value(typed);
}
