namespace Engraver.Core.Machines;

/// <summary>A terminal session in the controller's own language, line by line: commands are sent, replies are returned, and text printed by programs appears
/// between them.</summary>
/// <remarks>Disposing leaves the controller as it was found.</remarks>
public interface IMachineTerminal : IAsyncDisposable
{
    MachineIdentity Identity { get; }

    /// <summary>Lines as typed, oldest first.</summary>
    IReadOnlyList<string> History { get; }

    /// <summary>Whether a typed line ends the conversation.</summary>
    bool IsExitLine(string line);

    /// <summary>Answers one line: first the text that programs have printed so far, then the reply itself.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<IReadOnlyList<TerminalAnswer>> ExecuteLineAsync(string line, CancellationToken cancellation);

    /// <summary>Text that programs have printed since the last reply.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<IReadOnlyList<TerminalAnswer>> PollAsync(CancellationToken cancellation);

    /// <summary>Stops when the operator ends the program: the tool is switched off, all axes brake, and the method waits until the machine is at rest (ADR
    /// 4).</summary>
    /// <param name="toolOutput">The output that switches the tool, from 1.</param>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task StopAsync(int toolOutput, TimeSpan pollInterval);
}
