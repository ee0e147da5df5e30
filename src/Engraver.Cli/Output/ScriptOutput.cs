using Engraver.Workbench.Commands;

namespace Engraver.Cli.Output;

/// <summary>Writes the messages of commands as the runner's contract requires: results to standard output, everything else to standard error.</summary>
internal sealed class ScriptOutput(TextWriter results, TextWriter others, bool quiet, bool verbose)
{
    /// <summary>True after a message of severity error.</summary>
    public bool HasErrors { get; private set; }

    public void Write(object? sender, CommandMessage message)
    {
        HasErrors |= message.Kind == MessageKind.Error;
        if (message.Kind == MessageKind.Result) results.WriteLine(message.Text);
        else if (IsWanted(message.Kind)) others.WriteLine(message.Text);
    }

    private bool IsWanted(MessageKind kind) => kind switch
    {
        MessageKind.Error => true,
        MessageKind.Echo => verbose,
        _ => !quiet,
    };
}
