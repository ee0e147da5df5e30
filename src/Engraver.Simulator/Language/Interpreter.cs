using Engraver.Simulator.Language.Commands;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>Runs statements, one at a time.</summary>
internal sealed class Interpreter(Machine machine)
{
    private readonly StatementReader _reader = new(machine);
    private readonly StatementCache _cache = new();

    /// <summary>Runs a command of a host; a refusal is thrown as <see cref="CommandRefusedException"/>.</summary>
    public void Execute(ReadOnlySpan<char> source, CommandContext context) => Execute(_cache.Read(source), context);

    /// <inheritdoc cref="Execute(ReadOnlySpan{char}, CommandContext)"/>
    public void Execute(Statement statement, CommandContext context)
    {
        switch (statement.Kind)
        {
            case StatementKind.Command:
                Run(statement, statement.Command!, context);
                break;
            case StatementKind.Assignment:
                Assignments.Run(_reader.On(statement.Text, context));
                break;
            case StatementKind.Unknown:
                throw new CommandRefusedException(Tc.Unrecognized);
        }
    }

    private void Run(Statement statement, CommandEntry entry, CommandContext context)
    {
        if (context.IsProgram ? entry.Scope == CommandScope.Host : entry.Scope == CommandScope.Program)
            throw new CommandRefusedException(context.IsProgram ? Tc.NotInProgram : Tc.OnlyFromProgram);
        var reader = _reader.On(statement.Text, context);
        reader.Skip(entry.Mnemonic.Length);
        entry.Run(reader);
    }
}

/// <summary>The last statements of hosts in parsed form: a polling host sends the same statement thousands of times.</summary>
internal sealed class StatementCache
{
    private const int Places = 64;
    private readonly (string Source, Statement Statement)[] _known = new (string, Statement)[Places];

    public Statement Read(ReadOnlySpan<char> source)
    {
        ref var place = ref _known[(uint)string.GetHashCode(source) % Places];
        if (place.Source is { } known && source.SequenceEqual(known)) return place.Statement;
        place = (source.ToString(), Statement.Parse(source));
        return place.Statement;
    }
}
