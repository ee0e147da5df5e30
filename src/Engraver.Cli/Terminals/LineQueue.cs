using System.Threading.Channels;

namespace Engraver.Cli.Terminals;

/// <summary>Lines for a terminal, written in order by a separate task: a blocked terminal (Ctrl-S, text selected with the mouse) does not delay its callers,
/// above all not the heartbeat of a job.</summary>
internal sealed class LineQueue : IAsyncDisposable
{
    private readonly Channel<string> _lines = Channel.CreateUnbounded<string>(new UnboundedChannelOptions { SingleReader = true });
    private readonly Task _writing;

    /// <param name="write">Writes one line; may block.</param>
    public LineQueue(Action<string> write) => _writing = Task.Run(() => WriteAsync(write));

    public void Enqueue(string line) => _lines.Writer.TryWrite(line);

    /// <summary>Waits until all queued lines are written.</summary>
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
