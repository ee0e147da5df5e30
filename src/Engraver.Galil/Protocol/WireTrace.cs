using System.Globalization;

namespace Engraver.Galil.Protocol;

/// <summary>Every line sent and every reply received, with the time, for <c>--trace</c>. Several channels may write into one trace.</summary>
/// <remarks>A line is: seconds since the trace began, the handle's name, <c>&gt;</c> sent or <c>&lt;</c> received or <c>!</c> unsolicited, the text.
/// A trace that cannot be written any more, above all on a full disk, ends there and disturbs nothing: the stop of the machine goes over the same channels.</remarks>
public sealed class WireTrace(TextWriter writer, TimeProvider time)
{
    private readonly Lock _gate = new();
    private readonly long _start = time.GetTimestamp();

    /// <summary>Why the trace ended early; null while all of it was written.</summary>
    public string? Failure { get; private set; }

    /// <summary>What is still buffered goes to the file, and the file is closed.</summary>
    public void Close() => Guarded(writer.Dispose);

    internal void Write(string handle, char direction, string text)
    {
        var seconds = time.GetElapsedTime(_start).TotalSeconds.ToString("0.000000", CultureInfo.InvariantCulture);
        var visible = text.Replace("\r", "", StringComparison.Ordinal).Replace("\n", " | ", StringComparison.Ordinal).Replace("\x12\x16", "^R^V", StringComparison.Ordinal);
        if (Failure is null) Guarded(() => writer.WriteLine($"{seconds} {handle} {direction} {visible}"));
    }

    private void Guarded(Action write)
    {
        lock (_gate)
        {
            try
            {
                write();
            }
            catch (IOException unwritten)
            {
                Failure ??= unwritten.Message;
            }
        }
    }
}
