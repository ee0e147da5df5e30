using Engraver.Simulator.Language.Commands;
using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Language;

/// <summary>One statement, parsed once and run any number of times: its type, and its text without meaningless blanks.</summary>
internal sealed class Statement
{
    private Statement(StatementKind kind, string text, CommandEntry? command)
    {
        Kind = kind;
        Text = text;
        Command = command;
    }

    public StatementKind Kind { get; }

    public string Text { get; }

    /// <summary>Its row of the dispatch table; null unless it is a command.</summary>
    public CommandEntry? Command { get; }

    public static Statement Parse(ReadOnlySpan<char> source)
    {
        var text = Statements.Compact(source);
        if (text.Length == 0 || text[0] == '\'') return new(StatementKind.Nothing, text, null);
        if (FindCommand(text) is { } entry) return new(StatementKind.Command, text, entry);
        var plain = WithoutBlank(text);
        return text[0] == '~' || (IsAssignment(plain) && !HasAbsentMnemonic(text)) ? new(StatementKind.Assignment, plain, null) : new(StatementKind.Unknown, text, null);
    }

    /// <summary>The command a statement starts with, or null when it is not a command, or is the name of a variable that starts like one.</summary>
    private static CommandEntry? FindCommand(string statement)
    {
        var entry = CommandTable.Find(statement);
        if (entry is null || !char.IsAsciiLetterUpper(statement[0])) return entry;
        var end = entry.Mnemonic.Length;
        if (end == statement.Length || statement[end] == ' ') return entry;
        var name = NameLength(statement);
        var assigned = name < statement.Length && statement[name] is '=' or '[' && IsAssignment(WithoutBlank(statement));
        return assigned && !IsAxisAssignment(statement, entry, name) ? null : entry;
    }

    /// <summary>SPA=1000: the mnemonic, one axis, plane or handle letter, an equals sign. SP=1000 without a letter is also the command, and is refused when it
    /// runs.</summary>
    private static bool IsAxisAssignment(string statement, CommandEntry entry, int name) =>
        name == entry.Mnemonic.Length
        || (entry.TakesLetter && name == entry.Mnemonic.Length + 1 && IsLetterOfMachine(statement[name - 1]));

    private static bool IsLetterOfMachine(char c) => AxisSelection.IndexOf(c) >= 0 || c is >= 'A' and <= 'H' or 'S' or 'T';

    private static bool IsAssignment(string text)
    {
        var name = NameLength(text);
        if (name == 0 || name == text.Length || char.IsAsciiDigit(text[0]) || IsCommandNotModelled(text, name)) return false;
        if (text[name] != '[') return text[name] == '=';
        var close = MatchingBracket(text, name);
        return close >= 0 && close + 1 < text.Length && text[close + 1] == '=';
    }

    /// <summary>True for EW 1=5: with the blank it is a command (which this controller does not have); without it, EW1=5 is a variable.</summary>
    private static bool HasAbsentMnemonic(string text) => text.Length > 2 && text[2] == ' ' && CommandTable.IsNotModelled(text[..2]);

    private static bool IsCommandNotModelled(string text, int name) =>
        name is 2 or 3 && CommandTable.IsNotModelled(text[..2]) && (name == 2 || IsLetterOfMachine(text[2]));

    private static int NameLength(string text)
    {
        var i = 0;
        while (i < text.Length && (char.IsAsciiLetterOrDigit(text[i]) || (text[i] == '_' && i > 0))) i++;
        return i;
    }

    private static int MatchingBracket(string text, int open)
    {
        var depth = 0;
        for (var i = open; i < text.Length; i++)
        {
            depth += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
            if (depth == 0) return i;
        }

        return -1;
    }

    private static string WithoutBlank(string statement) =>
        statement.Length > 2 && statement[2] == ' ' ? string.Concat(statement.AsSpan(0, 2), statement.AsSpan(3)) : statement;
}

internal enum StatementKind
{
    /// <summary>True for an empty statement: blank, or a comment after an apostrophe.</summary>
    Nothing,
    Command,
    Assignment,
    Unknown,
}
