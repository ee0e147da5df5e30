namespace Engraver.Workbench.Commands;

/// <summary>The running command, and the transparent one inside it.</summary>
internal sealed class FrameStack
{
    private readonly Stack<CommandFrame> _frames = new();

    /// <summary>The innermost; null while none runs.</summary>
    public CommandFrame? Top => _frames.TryPeek(out var frame) ? frame : null;

    /// <summary>A command runs inside another.</summary>
    public bool IsNested => _frames.Count > 1;

    /// <summary>Stands before the prompt of a command inside another.</summary>
    public string Before => IsNested ? new string('>', 2 * (_frames.Count - 1)) : "";

    public CommandFrame Push(CommandInfo info)
    {
        var frame = new CommandFrame(info);
        _frames.Push(frame);
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
        foreach (var frame in _frames.ToArray()) frame.Cancel();
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
        while (_frames.TryPeek(out var frame) && frame.Ended.IsCompleted) _frames.Pop().Dispose();
    }
}
