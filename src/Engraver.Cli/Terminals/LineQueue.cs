using System.Threading.Channels;

namespace Engraver.Cli.Terminals;

/// <summary>Lines for a terminal, written in the order in which they are said by a task of their own: a terminal that takes nothing (Ctrl-S, a selection by
/// the mouse) holds up nobody who speaks to it, above all not the heartbeat of a job.</summary>
internal sealed class LineQueue : IAsyncDisposable
{
    private readonly Channel<string> _lines = Channel.CreateUnbounded<string>(new UnboundedChannelOptions { SingleReader = true });
    private readonly Task _writing;

    /// <param name="write">Writes one line; may block.</param>
    public LineQueue(Action<string> write) => _writing = Task.Run(() => WriteAsync(write));

    public void Say(string line) => _lines.Writer.TryWrite(line);

    /// <summary>Waits until everything that was said is written.</summary>
    public async ValueTask DisposeAsync()
    {
        _lines.Writer.TryComplete();
        await _writing.ConfigureAwait(false);
    }

    private async Task WriteAsync(Action<string> write)
    {
        await foreach (var line in _lines.Reader.ReadAllAsync(CancellationToken.None).ConfigureAwait(false)) write(line);
    }
}
