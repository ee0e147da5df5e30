using System.Runtime.InteropServices;
using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Galil.Protocol;

/// <summary>Divides received bytes into replies: finds the prompts and removes unsolicited text. The result does not depend on how the bytes are divided into
/// packets.</summary>
/// <remarks>A prompt is at the start of a line, so that a colon inside a data line is not a prompt. Bytes with bit 7 set are unsolicited characters
/// (galil-dmc.md A.5, CW 1) except inside a binary record and in an uploaded program, which is returned byte for byte while no program runs. Not thread-safe:
/// the channel has one command at a time.</remarks>
public sealed class ReplyFramer
{
    /// <summary>Maximum accepted length of a reply, bytes; a full program memory is 80,000.</summary>
    public const int LongestReply = 1 << 20;

    private const byte CtrlZ = 0x1A;
    private readonly List<byte> _data = [];
    private readonly List<byte> _message = [];
    private readonly Queue<ReplyFrame> _frames = new();
    private int _recordLength;

    /// <summary>The shape of the present reply.</summary>
    public ReplyShape Shape { get; private set; }

    /// <summary>Called with each unsolicited line, without its line end.</summary>
    public Action<string>? MessageReceived { get; init; }

    /// <summary>Call before a command is sent. Discards the rest of an earlier reply (the extra colon that a trailing <c>;</c> may cause, text under CW
    /// 2).</summary>
    /// <param name="recordLength">Bytes of the record when <paramref name="shape"/> is <see cref="ReplyShape.Record"/>.</param>
    public void Expect(ReplyShape shape, int recordLength)
    {
        Shape = shape;
        _recordLength = recordLength;
        _data.Clear();
        _frames.Clear();
    }

    /// <exception cref="ProtocolViolationException">More than <see cref="LongestReply"/> bytes came without a prompt.</exception>
    public void Append(ReadOnlySpan<byte> bytes)
    {
        foreach (var value in bytes) Append(value);
    }

    /// <summary>Takes the oldest complete reply.</summary>
    public bool TryTake(out ReplyFrame frame) => _frames.TryDequeue(out frame);

    private void Append(byte value)
    {
        var inRecord = Shape == ReplyShape.Record && _data.Count < _recordLength && !(_data.Count == 0 && value == '?');
        if (inRecord || (Shape == ReplyShape.Upload && value >= 0x80)) _data.Add(value);
        else if (value >= 0x80) AppendToMessage((byte)(value - 0x80));
        else if (IsPrompt(value)) Complete(value == ':');
        else _data.Add(value);
        if (_data.Count > LongestReply) throw new ProtocolViolationException(Wording.Get("ReplyFramer.NoPrompt", LongestReply));
    }

    private bool IsPrompt(byte value)
    {
        if (value is not ((byte)':' or (byte)'?')) return false;
        if (Shape == ReplyShape.Greeting) return value == ':' && EchoHandshake.IsAnswered(CollectionsMarshal.AsSpan(_data));
        if (_data.Count == 0) return value == '?' || Shape != ReplyShape.Record;
        return Shape switch
        {
            ReplyShape.Upload => _data[^1] is CtrlZ or (byte)'\\',
            ReplyShape.Record => _data.Count == _recordLength,
            _ => _data[^1] == '\n',
        };
    }

    private void Complete(bool accepted)
    {
        var data = _data.Count == 0 ? "" : Encoding.Latin1.GetString([.. _data]);
        _data.Clear();
        _frames.Enqueue(new ReplyFrame(accepted, data));
        if (Shape == ReplyShape.Greeting) Shape = ReplyShape.Text; // bytes after it belong to a line that was sent meanwhile
    }

    private void AppendToMessage(byte character)
    {
        if (character != '\n' && character != '\r') _message.Add(character);
        if (character != '\n' && _message.Count < LongestReply) return;
        MessageReceived?.Invoke(Encoding.ASCII.GetString([.. _message]));
        _message.Clear();
    }
}

/// <summary>The first lines on a serial line, for any state in which an earlier host left it (galil-dmc.md A.2, F.2, F.4).</summary>
/// <remarks>The backslash ends an open download, and makes an incomplete command invalid, so that it is refused and not executed. Then the echo is switched
/// off. The reply to the last line cannot be confused with its echo: prompts are counted from there.</remarks>
internal static class EchoHandshake
{
    public const string Text = "\\\rEO 0\rMG \"READY\"";

    private const string EchoOff = "EO 0";

    private static ReadOnlySpan<byte> Answer => "READY\r\n"u8;

    /// <summary>True when a colon after these bytes is the prompt of the last line.</summary>
    public static bool IsAnswered(ReadOnlySpan<byte> received) => received.EndsWith(Answer);

    /// <summary>True when the controller has echoed the lines: EO was 1.</summary>
    public static bool WasEchoed(string received) => received.Contains(EchoOff, StringComparison.Ordinal);
}
