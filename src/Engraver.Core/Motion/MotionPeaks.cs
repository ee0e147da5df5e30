using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>The highest demands of a motion program on the machine while it cuts.</summary>
/// <param name="Speed">Fastest along the path, mm/s.</param>
/// <param name="AxisAcceleration">Largest of one axis, mm/s2: along the path, across it in arcs, and the turn between two segments that are run without a stop,
/// averaged over one sample.</param>
public readonly record struct MotionPeaks(double Speed, double AxisAcceleration)
{
    /// <summary>Number of points at which an arc is evaluated; between them the acceleration of an axis changes by less than a thousandth on arcs of up to a
    /// quarter turn.</summary>
    private const int PlacesOfArc = 32;

    /// <summary>Time between two samples of the motors by the controller, in which a turn of the path takes place, seconds.</summary>
    private const double Sample = 0.001;

    /// <summary>Both values are 0 when nothing is cut.</summary>
    public static MotionPeaks From(MotionProgram program)
    {
        var peaks = default(MotionPeaks);
        foreach (var sequence in program.Strokes.SelectMany(stroke => stroke.Sequences)) peaks = peaks.Including(sequence, program.Profile);
        return peaks;
    }

    /// <summary>The peaks together with those of one sequence.</summary>
    private MotionPeaks Including(VectorSequence sequence, MachineProfile profile)
    {
        var (peakSpeed, peakAcceleration) = this;
        var kinematics = new SequenceKinematics(SequenceProfile.Of(sequence, profile), profile.Scale);
        var travelled = 0.0;
        var from = sequence.Start;
        Vector2D? before = null;
        foreach (var segment in sequence.Segments)
        {
            if (before is { } velocity) peakAcceleration = Math.Max(peakAcceleration, LargestAxis((kinematics.VelocityAt(segment, from, 0.0, travelled) - velocity) * (1.0 / Sample)));
            for (var place = 0; place <= Places(segment); place++)
            {
                var fraction = (double)place / Places(segment);
                var path = travelled + (fraction * segment.Length);
                peakSpeed = Math.Max(peakSpeed, kinematics.VelocityAt(segment, from, fraction, path).Length);
                peakAcceleration = Math.Max(peakAcceleration, LargestAxis(kinematics.AccelerationAt(segment, from, fraction, path)));
            }

            travelled += segment.Length;
            before = kinematics.VelocityAt(segment, from, 1.0, travelled);
            from = segment.End;
        }

        return new MotionPeaks(peakSpeed, peakAcceleration);
    }

    /// <summary>A line needs its ends and its middle.</summary>
    private static int Places(in VectorSegment segment) => segment.Kind == VectorSegmentKind.Line ? 2 : PlacesOfArc;

    private static double LargestAxis(Vector2D vector) => Math.Max(Math.Abs(vector.X), Math.Abs(vector.Y));
}
