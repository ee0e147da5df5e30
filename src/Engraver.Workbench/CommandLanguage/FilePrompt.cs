using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for the name of a file. It may be quoted, relative to the home folder (<c>~/plate.dxf</c>), or a file URL; a desktop shows its file dialog
/// instead.</summary>
/// <param name="Request">Which files fit.</param>
public sealed record FilePrompt(string Instruction, FileRequest Request) : ValuePrompt<string>(Instruction)
{
    public override bool AllowsSpaces => true;

    public override FileRequest? FileRequest => Request;

    public override ParsedInput<string> Parse(string typed, Point2D lastPoint) => new ParsedInput<string>.Value(TypedFileName.Parse(typed));
}
