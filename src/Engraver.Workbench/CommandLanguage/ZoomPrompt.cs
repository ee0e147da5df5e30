using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a corner of a window or a scale factor: <c>x,y</c>, <c>2</c> or <c>2X</c>.</summary>
public sealed record ZoomPrompt(string Instruction) : ValuePrompt<ZoomWish>(Instruction)
{
    public override PointAim Aim => PointAim.FirstCorner;

    public override Reading<ZoomWish> Read(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var relative = typed[^1] is 'x' or 'X';
        if (NumberPrompt.TryNumber(relative ? typed[..^1] : typed, out var factor))
            return factor > 0.0 ? new Reading<ZoomWish>.Value(new ZoomWish.Scale(factor, relative)) : new Reading<ZoomWish>.Wrong("A scale factor must be above 0.");
        return new PointPrompt(Instruction).Read(typed, lastPoint) switch
        {
            Reading<Point2D>.Value point => new Reading<ZoomWish>.Value(new ZoomWish.Corner(point.Of)),
            _ => new Reading<ZoomWish>.Wrong($"'{typed}' is no corner and no scale; type x,y or 2 or 2X or an option."),
        };
    }
}
