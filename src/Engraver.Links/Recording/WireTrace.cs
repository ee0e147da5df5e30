using System.Globalization;
using Engraver.Core.Motion;

namespace Engraver.Links.Recording;

/// <summary>Every line sent and every reply received, with the time, for <c>--trace</c>. Several channels may write into one trace.</summary>
/// <remarks>A line is: seconds since the start of the trace, the handle's name, <c>&gt;</c> sent or <c>&lt;</c> received or <c>!</c> unsolicited, the text. A
/// separate thread writes the lines (<see cref="LineFile"/>).</remarks>
public sealed class WireTrace : IWireTrace
{
    internal const int MaxWaiting = LineFile.MaxWaiting;

    private readonly LineFile _file;
    private readonly TimeProvider _time;
    private readonly long _start;

    /// <param name="writer">Owned: closed after the last line.</param>
    /// <param name="time">The clock of the conversation, for the times in the lines.</param>
    /// <param name="wall">The wall clock, for the waits for the trace's reader; null when both are the same.</param>
    public WireTrace(TextWriter writer, TimeProvider time, TimeProvider? wall = null)
    {
        ArgumentNullException.ThrowIfNull(time);
        (_time, _start, _file) = (time, time.GetTimestamp(), new LineFile(writer, wall ?? time));
    }

    /// <summary>Why the trace ended early; null while all lines were written.</summary>
    public string? Failure => _file.Failure;

    internal static TimeSpan FlushTimeout => LineFile.FlushTimeout;

    /// <summary>Writes the waiting lines and closes the file.</summary>
    /// <param name="stop">The operator's stop: from then on the trace's reader is waited for only while it makes progress.</param>
    public Task CloseAsync(CancellationToken stop) => _file.CloseAsync(stop);

    public void Write(string handle, char direction, string text)
    {
        if (_file.Failure is not null) return;
        var seconds = _time.GetElapsedTime(_start).TotalSeconds.ToString("0.000000", CultureInfo.InvariantCulture);
        var visible = text.Replace("\r", "", StringComparison.Ordinal).Replace("\n", " | ", StringComparison.Ordinal).Replace("\x12\x16", "^R^V", StringComparison.Ordinal);
        _file.Write($"{seconds} {handle} {direction} {visible}");
    }
}
