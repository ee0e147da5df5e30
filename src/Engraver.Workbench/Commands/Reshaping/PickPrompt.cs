using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>Asks for an object at a place, as a <see cref="PointPrompt"/> takes it; <c>shift:</c> before the coordinates stands for a click with Shift,
/// which means the opposite (TRIM extends).</summary>
internal sealed record PickPrompt(string Instruction) : ValuePrompt<ObjectPick>(Instruction)
{
    /// <summary>What is typed before the coordinates of a click with Shift.</summary>
    public const string ShiftMark = "shift:";

    /// <summary>What a click would take or give (<see cref="PointAim.Ghost"/>).</summary>
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

/// <summary>A place at which an object was picked, drawing units.</summary>
/// <param name="IsShifted">With Shift held.</param>
internal readonly record struct ObjectPick(Point2D At, bool IsShifted);
