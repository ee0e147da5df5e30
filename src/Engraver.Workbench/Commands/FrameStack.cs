namespace Engraver.Workbench.Commands;

/// <summary>The running command, and the transparent one nested in it.</summary>
internal sealed class FrameStack
{
    /// <summary>Innermost first. Immutable, replaced on change: Esc and the window read it from other threads.</summary>
    private volatile CommandFrame[] _frames = [];

    /// <summary>The innermost; null if none runs.</summary>
    public CommandFrame? Top => _frames is [var top, ..] ? top : null;

    /// <summary>The outermost command; null if none runs.</summary>
    public CommandFrame? Outermost => _frames is [.., var first] ? first : null;

    /// <summary>Objects picked for the innermost command that asked for objects; null if there is none.</summary>
    public IReadOnlyList<int>? Picked => Array.Find(_frames, frame => frame.Picked is not null)?.Picked;

    /// <summary>True while a nested command runs.</summary>
    public bool IsNested => _frames.Length > 1;

    /// <summary>Prefix of the prompt of a nested command.</summary>
    public string PromptPrefix => IsNested ? new string('>', 2 * (_frames.Length - 1)) : "";

    public CommandFrame Push(CommandInfo info, bool hasNoDialog)
    {
        var frame = new CommandFrame(info) { SuppressesDialogs = hasNoDialog };
        _frames = [frame, .. _frames];
        return frame;
    }

    /// <summary>Waits until the command prompts or has ended. A command that ends with an exception is removed too, so that the next one can start.</summary>
    public async Task<InputResult> WaitForPromptOrEndAsync(CommandFrame frame, CancellationToken cancellation)
    {
        try
        {
            return await frame.WaitForPromptOrEndAsync(cancellation).ConfigureAwait(false);
        }
        finally
        {
            RemoveEnded();
        }
    }

    /// <summary>Cancels all commands.</summary>
    public void Cancel()
    {
        foreach (var frame in _frames) frame.Cancel();
    }

    /// <summary>Ends all commands and waits for them.</summary>
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
