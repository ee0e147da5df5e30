using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Programs;

/// <summary>Executes VP and CR as described in the reference (galil-dmc.md B.2, B.3), from the text that is sent. Written for the tests with plain
/// trigonometry, independent of the prediction.</summary>
internal sealed class SegmentReplay(double angleQuantum)
{
    private const double LongestStep = 3.0;

    /// <summary>Exact position in the job's frame.</summary>
    public double X { get; private set; }

    public double Y { get; private set; }

    /// <summary>Points of the path, 32 to 720 on a segment, with the entity that was being cut.</summary>
    public List<(Point2D Place, int Entity)> Track { get; } = [];

    /// <summary>Runs the sequence from its start; the controller is at rest there, on whole counts.</summary>
    public void Run(VectorSequence sequence)
    {
        X = sequence.Start.X;
        Y = sequence.Start.Y;
        foreach (var segment in sequence.Segments) Execute(DmcFormat.Command(segment, sequence.Start), sequence.Start, segment.EntityIndex);
    }

    private void Execute(string command, CountsPoint origin, int entity)
    {
        var numbers = command[3..].Split(',').Select(text => double.Parse(text, CultureInfo.InvariantCulture)).ToArray();
        if (command.StartsWith("VP ", StringComparison.Ordinal)) Straight(origin.X + numbers[0], origin.Y + numbers[1], entity);
        else Round(numbers[0], Kept(numbers[1]), Kept(numbers[2]), entity);
    }

    private void Straight(double x, double y, int entity)
    {
        var (fromX, fromY) = (X, Y);
        var steps = Steps(Math.Sqrt(((x - fromX) * (x - fromX)) + ((y - fromY) * (y - fromY))));
        for (var i = 1; i <= steps; i++) Track.Add((new Point2D(fromX + ((x - fromX) * i / steps), fromY + ((y - fromY) * i / steps)), entity));
        (X, Y) = (x, y);
    }

    private void Round(double radius, double theta, double delta, int entity)
    {
        const double Degree = Math.PI / 180.0;
        var centreX = X - (radius * Math.Cos(theta * Degree));
        var centreY = Y - (radius * Math.Sin(theta * Degree));
        var steps = Steps(radius * Math.Abs(delta) * Degree);
        for (var i = 1; i <= steps; i++)
        {
            var angle = (theta + (delta * i / steps)) * Degree;
            Track.Add((new Point2D(centreX + (radius * Math.Cos(angle)), centreY + (radius * Math.Sin(angle))), entity));
        }

        (X, Y) = (Track[^1].Place.X, Track[^1].Place.Y);
    }

    /// <summary>A number in a command is truncated at 1/65536; CR may store it with a coarser step.</summary>
    private double Kept(double degrees) => Math.Round(Math.Truncate(Math.Round(degrees * 65536.0, 6)) / 65536.0 / angleQuantum) * angleQuantum;

    private static int Steps(double length) => (int)Math.Clamp(length / LongestStep, 32, 720);
}
