using System.Text;
using System.Threading.Channels;
using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Links;

/// <summary>A simple controller on a serial line at 19,200 baud: it echoes received lines, answers the known ones and sends a prompt for the others. It can
/// delay the reply to one line until it is released.</summary>
/// <param name="answers">The reply to a command, including its line end; "" is a prompt only.</param>
internal sealed class EchoingLink(Func<string, string> answers, EchoTime echo) : IControllerLink
{
    private readonly Channel<byte[]> _sent = Channel.CreateUnbounded<byte[]>();
    private readonly StringBuilder _behind = new();
    private string? _keeps;
    private bool _echoes;
    private int _greets; // lines of a greeting that are still to come

    public string Description => "echoing";

    public SerialLine? Line { get; } = new(19200);

    /// <summary>The line whose reply is delayed, once; null for none.</summary>
    public string? Kept { private get; set; }

    /// <summary>Returns the bytes that arrive instead of a line.</summary>
    public Func<string, string> Corrupt { private get; set; } = line => line;

    /// <summary>Returns all bytes that come back for a line with its CR, instead of its echo and its prompts; null leaves them to this class.</summary>
    public Func<string, string?> Heard { private get; set; } = _ => null;

    /// <summary>Lines as received, in one piece or several.</summary>
    public List<string> Written { get; } = [];

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        var text = Encoding.Latin1.GetString(bytes.Span);
        Written.Add(text);
        if (Heard(text) is { } heard) Reply(heard);
        else foreach (var line in text.Split('\r', StringSplitOptions.RemoveEmptyEntries)) Receive(Corrupt(line));
        return ValueTask.CompletedTask;
    }

    /// <summary>Sends the delayed reply and everything that waits after it.</summary>
    public void Release()
    {
        var answer = _keeps! + _behind;
        _keeps = null;
        Reply(answer);
    }

    public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
    {
        if (!await _sent.Reader.WaitToReadAsync(cancellation)) return 0;
        _sent.Reader.TryRead(out var next);
        next!.CopyTo(buffer);
        return next!.Length;
    }

    public ValueTask DisposeAsync()
    {
        _sent.Writer.TryComplete();
        return ValueTask.CompletedTask;
    }

    private void Receive(string line)
    {
        if (line == "\\") _greets = 3;
        if (line == "EO 0") _echoes = false;
        var replies = string.Concat(line.Split(';').Select(part => _greets == 3 ? "?" : _greets == 1 ? "READY\r\n:" : answers(part) + ":"));
        _greets = Math.Max(0, _greets - 1);
        var heard = _echoes ? line + "\r" : "";
        if (line == "EO 1") _echoes = true;
        if (line == Kept)
        {
            Reply(heard);
            (_keeps, Kept) = (replies, null);
        }
        else if (_keeps is null) Reply(heard + replies);
        else Overtake(heard, replies);
    }

    /// <summary>A line after the one whose reply is delayed.</summary>
    private void Overtake(string heard, string replies)
    {
        if (echo == EchoTime.BehindTheAnswer || heard.Length == 0)
        {
            _behind.Append(heard).Append(replies);
            return;
        }

        var head = heard[..(heard.Length / 2)];
        Reply(echo == EchoTime.BeforeTheAnswer ? heard : head);
        if (echo == EchoTime.AmidTheAnswer) _keeps = _keeps![..2] + heard[head.Length..] + _keeps[2..];
        _behind.Append(replies);
    }

    private void Reply(string text)
    {
        if (text.Length > 0) _sent.Writer.TryWrite(Encoding.Latin1.GetBytes(text)); // an empty read would be the end of the link
    }
}
