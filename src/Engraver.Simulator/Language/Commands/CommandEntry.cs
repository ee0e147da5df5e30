namespace Engraver.Simulator.Language.Commands;

/// <summary>One row of the dispatch table.</summary>
/// <param name="TakesLetter">The form mnemonic + letter + "=" belongs to the command and not to a variable.</param>
internal sealed record CommandEntry(string Mnemonic, CommandScope Scope, Action<StatementReader> Run, bool TakesLetter = false);
