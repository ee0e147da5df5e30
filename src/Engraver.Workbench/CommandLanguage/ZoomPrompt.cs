using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a corner of a window or a scale factor: <c>x,y</c>, <c>2</c> or <c>2X</c>.</summary>
public sealed record ZoomPrompt(string Instruction) : ValuePrompt<ZoomRequest>(Instruction)
{
    public override PointRequest PointRequest => PointRequest.FirstCorner;

    public override ParsedInput<ZoomRequest> Parse(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var relative = typed[^1] is 'x' or 'X';
        if (NumberPrompt.TryParse(relative ? typed[..^1] : typed, out var factor))
            return factor > 0.0 ? new ParsedInput<ZoomRequest>.Value(new ZoomRequest.Scale(factor, relative)) : new ParsedInput<ZoomRequest>.Invalid(Wording.Get("ZoomPrompt.ScaleFactorNotPositive"));
        return new PointPrompt(Instruction).Parse(typed, lastPoint) switch
        {
            ParsedInput<Point2D>.Value point => new ParsedInput<ZoomRequest>.Value(new ZoomRequest.WindowCorner(point.Result)),
            _ => new ParsedInput<ZoomRequest>.Invalid(Wording.Get("ZoomPrompt.InvalidInput", typed)),
        };
    }
}
