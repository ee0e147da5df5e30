namespace Engraver.Galil.Protocol;

/// <summary>What an operator wants to know about one command of the controller.</summary>
/// <param name="Command">Its letters.</param>
/// <param name="Form">How it is written, with an example where that says more.</param>
/// <param name="Meaning">What it does, with unit and range.</param>
public sealed record CommandHelp(string Command, string Form, string Meaning)
{
    /// <summary>One line for a terminal.</summary>
    public override string ToString() => $"{Command}  {Form}: {Meaning}";
}
