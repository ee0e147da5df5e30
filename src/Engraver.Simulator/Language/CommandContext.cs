using Engraver.Simulator.Protocol;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>The issuer of a command: a host on a handle, or a program thread. Exactly one of the two is set.</summary>
internal sealed class CommandContext
{
    private CommandContext(Handle? handle, ProgramThread? thread)
    {
        Handle = handle;
        Thread = thread;
    }

    public Handle? Handle { get; }

    public ProgramThread? Thread { get; }

    /// <summary>Text that the command printed, as Latin-1 characters: the reply to a host, or an unsolicited message of a program.</summary>
    public TextBuffer Output { get; } = new();

    /// <summary>The handle to which {Ex} sends a program message; null when CF selects it.</summary>
    public int? OutputHandle { get; set; }

    public bool IsProgram => Thread is not null;

    /// <summary>Clears the output, ready for the next command of the same host or thread.</summary>
    public CommandContext Restart()
    {
        Output.Clear();
        OutputHandle = null;
        return this;
    }

    public static CommandContext From(Handle handle) => new(handle, null);

    public static CommandContext From(ProgramThread thread) => new(null, thread);

    public void WriteLine(string text) => Output.Append(text).Append("\r\n");

    public void WriteNumber(NumberFormat format, FixedPoint value)
    {
        Span<char> text = stackalloc char[NumberFormat.Longest];
        Output.Append(text[..format.Write(text, value)]);
    }
}
