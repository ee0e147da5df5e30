using System.Globalization;
using Engraver.Core;
using Engraver.Core.Machines;

namespace Engraver.Galil.Language;

/// <summary>Writes numbers and vector segments for the controller: decimal point, no exponent, at most four decimals (galil-dmc.md F.5).</summary>
public static class DmcFormat
{
    /// <summary>A number with at most four decimals. The caller takes into account how the controller rounds it (angle quantum).</summary>
    public static string Number(double value) => NumberText.RoundedWithoutMinusZero(value, 4);

    /// <summary>DMC text with numbers in it.</summary>
    public static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    /// <summary>VP or CR for one segment; VP is written relative to the start of its sequence, as the controller expects it (galil-dmc.md B.2).</summary>
    public static string Command(in VectorSegment segment, CountsPoint sequenceStart) => segment.Kind switch
    {
        VectorSegmentKind.Line => string.Create(CultureInfo.InvariantCulture, $"VP {(long)segment.End.X - sequenceStart.X},{(long)segment.End.Y - sequenceStart.Y}"),
        VectorSegmentKind.Arc => string.Create(CultureInfo.InvariantCulture, $"CR {segment.Radius},{Number(segment.ThetaDegrees)},{Number(segment.DeltaDegrees)}"),
        _ => throw new ArgumentOutOfRangeException(nameof(segment)),
    };

    /// <summary>The segments of a sequence as commands, in order: VP and CR, or LI if the sequence changes height; with their speeds.</summary>
    public static IEnumerable<string> Commands(VectorSequence sequence, MachineAxes axes)
    {
        var (from, states) = (sequence.Start, sequence.HasOwnSpeeds);
        foreach (var segment in sequence.Segments)
        {
            yield return (sequence.ChangesHeight ? Increment(axes, from, segment.End) : Command(segment, sequence.Start)) + (states ? Speed(sequence.SpeedOf(segment)) : string.Empty);
            from = segment.End;
        }
    }

    /// <summary>The speed that is commanded from the start of a segment. Where one segment of a sequence states it, every one does: a segment without it runs
    /// at the speed before it or at VS (galil-dmc.md B.1 and B.4 differ).</summary>
    public static string Speed(int countsPerSecond) => Text($"<{countsPerSecond}");

    /// <summary>LI for a line in three axes.</summary>
    public static string Increment(MachineAxes axes, CountsPoint from, CountsPoint to) => "LI " + DmcAxes.Fields(axes, [Difference(from.X, to.X), Difference(from.Y, to.Y), Difference(from.Z, to.Z)]);

    private static string Difference(long from, long to) => (to - from).ToString(CultureInfo.InvariantCulture);

    /// <summary>LI: a line by its increments, for a sequence started with LM (galil-dmc.md B.1).</summary>
    public static string Increment(CountsPoint from, CountsPoint to) => string.Create(CultureInfo.InvariantCulture, $"LI {to.X - from.X},{to.Y - from.Y}");
}
