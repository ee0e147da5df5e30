using System.Globalization;

namespace Engraver.Galil.Protocol;

/// <summary>Every line sent and every reply received, with the time, for <c>--trace</c>. Several channels may write into one trace.</summary>
/// <remarks>A line is: seconds since the trace began, the handle's name, <c>&gt;</c> sent or <c>&lt;</c> received or <c>!</c> unsolicited, the text.</remarks>
public sealed class WireTrace(TextWriter writer, TimeProvider time)
{
    private readonly Lock _gate = new();
    private readonly long _start = time.GetTimestamp();

    internal void Write(string handle, char direction, string text)
    {
        var seconds = time.GetElapsedTime(_start).TotalSeconds.ToString("0.000000", CultureInfo.InvariantCulture);
        var visible = text.Replace("\r", "", StringComparison.Ordinal).Replace("\n", " | ", StringComparison.Ordinal).Replace("\x12\x16", "^R^V", StringComparison.Ordinal);
        lock (_gate) writer.WriteLine($"{seconds} {handle} {direction} {visible}");
    }
}
