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
        var (speed, acceleration) = (0.0, 0.0);
        foreach (var sequence in program.Strokes.SelectMany(stroke => stroke.Sequences))
        {
            var ride = new SequencePeaks(sequence, program.Profile.AccelerationCounts, program.Profile.Scale);
            ride.Through(ref speed, ref acceleration);
        }

        return new MotionPeaks(speed, acceleration);
    }

    /// <summary>One sequence from its start to its end, in counts; its results are in millimetres.</summary>
    private sealed class SequencePeaks(VectorSequence sequence, double acceleration, CountsScale scale)
    {
        private readonly double _length = sequence.Length;

        public void Through(ref double peakSpeed, ref double peakAcceleration)
        {
            var travelled = 0.0;
            var from = sequence.Start;
            Vector2D? before = null;
            foreach (var segment in sequence.Segments)
            {
                if (before is { } tangent) peakAcceleration = Math.Max(peakAcceleration, LargestAxis((Direction(segment, from, 0.0) - tangent) * (SpeedAt(travelled) / Sample)));
                for (var place = 0; place <= Places(segment); place++)
                {
                    var fraction = (double)place / Places(segment);
                    var path = travelled + (fraction * segment.Length);
                    var (speed, direction) = (SpeedAt(path), Direction(segment, from, fraction));
                    peakSpeed = Math.Max(peakSpeed, scale.ToMillimetres(direction * speed).Length);
                    peakAcceleration = Math.Max(peakAcceleration, LargestAxis((direction * Gain(path)) + Inwards(segment, direction, speed)));
                }

                before = Direction(segment, from, 1.0);
                travelled += segment.Length;
                from = segment.End;
            }
        }

        /// <summary>A line needs its ends and its middle.</summary>
        private static int Places(in VectorSegment segment) => segment.Kind == VectorSegmentKind.Line ? 2 : PlacesOfArc;

        private double SpeedAt(double path) => Math.Min(sequence.Speed, Math.Sqrt(2.0 * acceleration * Math.Max(0.0, Math.Min(path, _length - path))));

        /// <summary>Acceleration along the path: up to speed, at speed, or down to rest.</summary>
        private double Gain(double path) => SpeedAt(path) >= sequence.Speed ? 0.0 : path <= _length / 2.0 ? acceleration : -acceleration;

        /// <summary>Direction of travel, length 1.</summary>
        private static Vector2D Direction(in VectorSegment segment, CountsPoint from, double fraction)
        {
            if (segment.Kind == VectorSegmentKind.Line)
            {
                var direction = new Vector2D((double)segment.End.X - from.X, (double)segment.End.Y - from.Y);
                return direction * (1.0 / Math.Max(direction.Length, double.Epsilon));
            }

            var spoke = Angle.FromDegrees(segment.ThetaDegrees + (fraction * segment.DeltaDegrees));
            return new Vector2D(-spoke.Sin(), spoke.Cos()) * Math.Sign(segment.DeltaDegrees);
        }

        /// <summary>Towards the centre of an arc: v2/r.</summary>
        private static Vector2D Inwards(in VectorSegment segment, Vector2D direction, double speed) => segment.Kind == VectorSegmentKind.Line
            ? default
            : new Vector2D(-direction.Y, direction.X) * (Math.Sign(segment.DeltaDegrees) * speed * speed / segment.Radius);

        private double LargestAxis(Vector2D counts) => scale.ToMillimetres(counts) is var at ? Math.Max(Math.Abs(at.X), Math.Abs(at.Y)) : 0.0;
    }
}
