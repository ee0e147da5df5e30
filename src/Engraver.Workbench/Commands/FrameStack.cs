namespace Engraver.Workbench.Commands;

/// <summary>The running command, and the transparent one inside it.</summary>
internal sealed class FrameStack
{
    /// <summary>Innermost first. Replaced and never changed: Esc and the window look at it from other threads.</summary>
    private volatile CommandFrame[] _frames = [];

    /// <summary>The innermost; null while none runs.</summary>
    public CommandFrame? Top => _frames is [var top, ..] ? top : null;

    /// <summary>The one that was begun first; null while none runs.</summary>
    public CommandFrame? Outermost => _frames is [.., var first] ? first : null;

    /// <summary>What was picked for the innermost command that asked for objects; null while none did.</summary>
    public IReadOnlyList<int>? Picked => Array.Find(_frames, frame => frame.Picked is not null)?.Picked;

    /// <summary>A command runs inside another.</summary>
    public bool IsNested => _frames.Length > 1;

    /// <summary>Stands before the prompt of a command inside another.</summary>
    public string Before => IsNested ? new string('>', 2 * (_frames.Length - 1)) : "";

    public CommandFrame Push(CommandInfo info, bool hasNoDialog)
    {
        var frame = new CommandFrame(info) { HasNoDialog = hasNoDialog };
        _frames = [frame, .. _frames];
        return frame;
    }

    /// <summary>Waits until the command asks or has ended. A command that ends by an exception is removed too, so that the next one can begin.</summary>
    public async Task<InputResult> SettledAsync(CommandFrame frame, CancellationToken cancellation)
    {
        try
        {
            return await frame.SettledAsync(cancellation).ConfigureAwait(false);
        }
        finally
        {
            RemoveEnded();
        }
    }

    /// <summary>Tells all to end.</summary>
    public void Cancel()
    {
        foreach (var frame in _frames) frame.Cancel();
    }

    /// <summary>Ends all and waits for it.</summary>
    public async Task EndAllAsync()
    {
        Cancel();
        await Task.WhenAll(_frames.Select(frame => frame.Ended)).ConfigureAwait(false);
        RemoveEnded();
    }

    private void RemoveEnded()
    {
        while (_frames is [{ Ended.IsCompleted: true } ended, .. var rest])
        {
            _frames = rest;
            ended.Dispose();
        }
    }
}
