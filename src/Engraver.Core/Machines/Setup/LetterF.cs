using Engraver.Core.Geometry;

namespace Engraver.Core.Machines.Setup;

/// <summary>The letter F, which looks different in each of the eight ways in which two axes can be mirrored and swapped. It is drawn in one stroke, ends where
/// it begins, and is 10 mm high and 6 mm wide.</summary>
public static class LetterF
{
    public const double Height = 10.0;

    public const double Width = 6.0;

    private const double Middle = 6.0;
    private const double ShortBar = 4.0;

    /// <summary>The corners in the order of drawing, mm from the foot of the long stroke.</summary>
    public static IReadOnlyList<Point2D> Corners { get; } =
        [new(0, Height), new(Width, Height), new(0, Height), new(0, Middle), new(ShortBar, Middle), new(0, Middle), new(0, 0)];

    /// <summary>The letter from the present position of the machine; it comes to rest at every corner.</summary>
    /// <param name="test">The machine, with the speed of the test moves.</param>
    /// <param name="drawn">The assumed axes; the two may be swapped compared with the machine's.</param>
    /// <param name="speed">Counts/s along the path, even.</param>
    public static MotionProgram Program(MachineProfile test, MachineAxes drawn, int speed)
    {
        ArgumentNullException.ThrowIfNull(test);
        ArgumentNullException.ThrowIfNull(drawn);
        var isSwapped = drawn.X.Letter != test.Axes.X.Letter;
        var from = default(CountsPoint);
        var sequences = new List<VectorSequence>();
        foreach (var place in Corners.Select(drawn.Scale.ToCounts))
        {
            var corner = isSwapped ? new CountsPoint(place.Y, place.X) : place;
            var length = Math.Sqrt(Math.Pow((double)corner.X - from.X, 2) + Math.Pow((double)corner.Y - from.Y, 2));
            sequences.Add(new VectorSequence(from, speed, [new VectorSegment(VectorSegmentKind.Line, corner, 0, 0.0, 0.0, 0, length)]));
            from = corner;
        }

        return new MotionProgram(test, default, [new MotionStroke(0, default, sequences)]);
    }

    /// <summary>The axes with which the letter is upright and not mirrored, for the result that was seen.</summary>
    /// <param name="axes">The axes with which it was drawn.</param>
    /// <param name="longStroke">Direction of the long stroke from its foot.</param>
    /// <param name="bars">Direction of the two bars from the long stroke.</param>
    /// <returns>Null when an F cannot look like that: long stroke and bars are collinear.</returns>
    public static MachineAxes? Corrected(MachineAxes axes, TableDirection longStroke, TableDirection bars)
    {
        ArgumentNullException.ThrowIfNull(axes);
        if (IsAcross(longStroke) == IsAcross(bars)) return null;
        var (movesAcross, movesAlong) = IsAcross(bars) ? ((axes.X, bars), (axes.Y, longStroke)) : ((axes.Y, longStroke), (axes.X, bars));
        return axes with { X = Turned(movesAcross), Y = Turned(movesAlong) };
    }

    /// <summary>The axis with its counts per millimetre negated, and with them the millimetres that the profile states for it.</summary>
    public static MachineAxis Mirrored(MachineAxis axis) => axis with
    {
        CountsPerMillimetre = axis.Scale.Mirrored().CountsPerMillimetre,
        Travel = axis.Travel is { } travel ? new AxisTravel(-travel.Max, -travel.Min) : null,
        Homing = axis.Homing is { } homing ? homing with { Plus = !homing.Plus, Zero = -homing.Zero } : null,
    };

    private static MachineAxis Turned((MachineAxis Axis, TableDirection Went) seen) => seen.Went is TableDirection.Right or TableDirection.Back ? seen.Axis : Mirrored(seen.Axis);

    private static bool IsAcross(TableDirection direction) => direction is TableDirection.Right or TableDirection.Left;
}
