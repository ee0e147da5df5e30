namespace Engraver.Core.Machines;

/// <summary>A conversation with a controller in its own language, line by line: commands go out, replies come back, and what programs print appears between them.</summary>
/// <remarks>Disposing leaves the controller as it was found.</remarks>
public interface IMachineTerminal : IAsyncDisposable
{
    MachineIdentity Identity { get; }

    /// <summary>Lines as typed, oldest first.</summary>
    IReadOnlyList<string> History { get; }

    /// <summary>Whether a typed line ends the conversation.</summary>
    bool Ends(string line);

    /// <summary>Answers one line: what programs have printed by now, then the answer itself.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<IReadOnlyList<TerminalAnswer>> AnswerAsync(string line, CancellationToken cancellation);

    /// <summary>What programs have printed since the last answer.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<IReadOnlyList<TerminalAnswer>> PollAsync(CancellationToken cancellation);

    /// <summary>The operator ends the program: the tool goes off, everything brakes, and the machine is waited for (ADR 4).</summary>
    /// <param name="toolOutput">The output that carries the tool, from 1.</param>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task StopAsync(int toolOutput, TimeSpan pollInterval);
}
