using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>Software flow control while a program is sent: XOFF pauses, XON resumes (DC3 and DC1 of ISO 646).</summary>
internal sealed class FlowControl(IProgramPort line, CharacterFrame frame, bool obeys)
{
    private const byte Xon = 0x11;
    private const byte Xoff = 0x13;

    private readonly Lock _guard = new();
    private TaskCompletionSource? _paused;
    private int _pauses;
    private long _otherBytes;

    /// <summary>Number of received XOFF.</summary>
    public int Pauses
    {
        get
        {
            lock (_guard) return _pauses;
        }
    }

    /// <summary>Number of received characters other than XON and XOFF.</summary>
    public long OtherBytes => Interlocked.Read(ref _otherBytes);

    /// <summary>Completes when sending is allowed.</summary>
    public Task WaitUntilOpenAsync()
    {
        lock (_guard) return _paused?.Task ?? Task.CompletedTask;
    }

    /// <summary>Listens until the line is closed or cancellation is requested.</summary>
    public async Task ListenAsync(CancellationToken cancellation)
    {
        var heard = new byte[64];
        try
        {
            while (await line.ReadAsync(heard, cancellation).ConfigureAwait(false) is > 0 and var count)
            {
                foreach (var bits in heard.AsSpan(0, count)) Process(frame.Decode(bits));
            }
        }
        catch (OperationCanceledException)
        {
            return;
        }
        catch (IOException)
        {
            Process(Xon); // The next write reports the failure of the line.
        }
    }

    private void Process(byte character)
    {
        if (character is not (Xon or Xoff)) Interlocked.Increment(ref _otherBytes);
        if (!obeys) return;
        TaskCompletionSource? opened = null;
        lock (_guard)
        {
            if (character == Xoff && _paused is null) (_paused, _pauses) = (new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously), _pauses + 1);
            if (character == Xon) (opened, _paused) = (_paused, null);
        }

        opened?.TrySetResult();
    }
}
