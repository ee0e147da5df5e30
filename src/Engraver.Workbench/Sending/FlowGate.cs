using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>Software flow control while a program is sent: XOFF pauses, XON resumes (DC3 and DC1 of ISO 646).</summary>
internal sealed class FlowGate(IProgramLine line, CharacterFrame frame, bool obeys)
{
    private const byte Xon = 0x11;
    private const byte Xoff = 0x13;

    private readonly Lock _guard = new();
    private TaskCompletionSource? _closed;
    private int _holds;
    private long _others;

    /// <summary>Number of received XOFF.</summary>
    public int Holds
    {
        get
        {
            lock (_guard) return _holds;
        }
    }

    /// <summary>Number of received characters other than XON and XOFF.</summary>
    public long Others => Interlocked.Read(ref _others);

    /// <summary>Completes when sending is allowed.</summary>
    public Task OpenAsync()
    {
        lock (_guard) return _closed?.Task ?? Task.CompletedTask;
    }

    /// <summary>Listens until the line is closed or cancellation is requested.</summary>
    public async Task ListenAsync(CancellationToken cancellation)
    {
        var heard = new byte[64];
        try
        {
            while (await line.ReadAsync(heard, cancellation).ConfigureAwait(false) is > 0 and var count)
            {
                foreach (var bits in heard.AsSpan(0, count)) Take(frame.Decode(bits));
            }
        }
        catch (OperationCanceledException)
        {
            return;
        }
        catch (IOException)
        {
            Take(Xon); // The next write reports the failure of the line.
        }
    }

    private void Take(byte character)
    {
        if (character is not (Xon or Xoff)) Interlocked.Increment(ref _others);
        if (!obeys) return;
        TaskCompletionSource? opened = null;
        lock (_guard)
        {
            if (character == Xoff && _closed is null) (_closed, _holds) = (new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously), _holds + 1);
            if (character == Xon) (opened, _closed) = (_closed, null);
        }

        opened?.TrySetResult();
    }
}
