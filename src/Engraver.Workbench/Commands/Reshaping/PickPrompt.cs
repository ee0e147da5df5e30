using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>Asks for an object at a point in the format of <see cref="PointPrompt"/>; the prefix <c>shift:</c> represents a click with Shift, which reverses
/// the command (TRIM extends).</summary>
internal sealed record PickPrompt(string Instruction) : ValuePrompt<ObjectPick>(Instruction)
{
    /// <summary>Prefix of the coordinates of a click with Shift.</summary>
    public const string ShiftMark = "shift:";

    /// <summary>Preview of a click (<see cref="PointAim.Ghost"/>).</summary>
    public GhostOf? Ghost { get; init; }

    public override PointAim Aim => new(PointUse.Object, null) { Ghost = Ghost, ShiftMark = ShiftMark };

    public override Reading<ObjectPick> Read(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var shifted = typed.StartsWith(ShiftMark, StringComparison.OrdinalIgnoreCase);
        var place = shifted ? typed[ShiftMark.Length..] : typed;
        return place.Length == 0 ? Wrong(typed) : new PointPrompt(Instruction).Read(place, lastPoint) switch
        {
            Reading<Point2D>.Value { Of: var at } => new Reading<ObjectPick>.Value(new ObjectPick(at, shifted)),
            Reading<Point2D>.Wrong wrong => new Reading<ObjectPick>.Wrong(wrong.Sentence),
            _ => throw new System.Diagnostics.UnreachableException(),
        };
    }

    private static Reading<ObjectPick> Wrong(string typed) => new Reading<ObjectPick>.Wrong(Wording.Get("PointPrompt.InvalidPoint", typed));
}

/// <summary>A pick point, drawing units.</summary>
/// <param name="IsShifted">True with Shift pressed.</param>
internal readonly record struct ObjectPick(Point2D At, bool IsShifted);
