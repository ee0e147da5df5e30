using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>Asks for an object at a point in the format of <see cref="PointPrompt"/>; the prefix <c>shift:</c> represents a click with Shift, which reverses
/// the command (TRIM extends).</summary>
internal sealed record PickPrompt(string Instruction) : ValuePrompt<ObjectPick>(Instruction)
{
    /// <summary>Prefix of the coordinates of a click with Shift.</summary>
    public const string ShiftPrefix = "shift:";

    /// <summary>Preview of a click (<see cref="PointRequest.Ghost"/>).</summary>
    public GhostFunction? Ghost { get; init; }

    public override PointRequest PointRequest => new(PointPurpose.Object, null) { Ghost = Ghost, ShiftPrefix = ShiftPrefix };

    public override ParsedInput<ObjectPick> Parse(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var shifted = typed.StartsWith(ShiftPrefix, StringComparison.OrdinalIgnoreCase);
        var place = shifted ? typed[ShiftPrefix.Length..] : typed;
        return place.Length == 0 ? InvalidPoint(typed) : new PointPrompt(Instruction).Parse(place, lastPoint) switch
        {
            ParsedInput<Point2D>.Value { Result: var at } => new ParsedInput<ObjectPick>.Value(new ObjectPick(at, shifted)),
            ParsedInput<Point2D>.Invalid wrong => new ParsedInput<ObjectPick>.Invalid(wrong.Message),
            _ => throw new System.Diagnostics.UnreachableException(),
        };
    }

    private static ParsedInput<ObjectPick> InvalidPoint(string typed) => new ParsedInput<ObjectPick>.Invalid(Wording.Get("PointPrompt.InvalidPoint", typed));
}

/// <summary>A pick point, drawing units.</summary>
/// <param name="IsShifted">True with Shift pressed.</param>
internal readonly record struct ObjectPick(Point2D At, bool IsShifted);
