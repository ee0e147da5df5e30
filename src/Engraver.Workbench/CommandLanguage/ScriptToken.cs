namespace Engraver.Workbench.CommandLanguage;

/// <summary>One input of a script.</summary>
/// <param name="Line">1 is the first line.</param>
/// <param name="Text">The input as typed; empty is Enter.</param>
public readonly record struct ScriptToken(int Line, string Text);
