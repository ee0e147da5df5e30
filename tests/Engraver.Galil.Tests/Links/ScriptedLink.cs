using System.Text;
using System.Threading.Channels;
using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Links;

/// <summary>A simple controller: answers each received line with the result of the script; null sends nothing.</summary>
internal sealed class ScriptedLink(Func<string, string?> script) : IControllerLink
{
    private readonly Channel<byte[]> _answers = Channel.CreateUnbounded<byte[]>();
    private readonly StringBuilder _line = new();
    private ReadOnlyMemory<byte> _rest;

    public string Description => "scripted";

    public List<string> Received { get; } = [];

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        foreach (var value in bytes.Span)
        {
            if (value is (byte)'\r' or (byte)'\\') EndLine();
            else _line.Append((char)value);
        }

        return ValueTask.CompletedTask;
    }

    /// <summary>Sends unsolicited bytes.</summary>
    public void Reply(string text) => _answers.Writer.TryWrite(Encoding.Latin1.GetBytes(text));

    public void Close() => _answers.Writer.TryComplete();

    public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
    {
        if (_rest.IsEmpty)
        {
            if (!await _answers.Reader.WaitToReadAsync(cancellation)) return 0;
            _answers.Reader.TryRead(out var next);
            _rest = next;
        }

        var count = Math.Min(buffer.Length, _rest.Length);
        _rest[..count].CopyTo(buffer);
        _rest = _rest[count..];
        return count;
    }

    public ValueTask DisposeAsync()
    {
        Close();
        return ValueTask.CompletedTask;
    }

    private void EndLine()
    {
        var line = _line.ToString();
        _line.Clear();
        Received.Add(line);
        if (script(line) is { } answer) Reply(answer);
    }
}
