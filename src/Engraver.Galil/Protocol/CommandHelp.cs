using Engraver.Core.Languages;

namespace Engraver.Galil.Protocol;

/// <summary>Help for one command of the controller.</summary>
/// <param name="Command">Its letters.</param>
/// <param name="Forms">Its syntax, with an example where useful; several forms are separated by a slash.</param>
public sealed record CommandHelp(string Command, string Forms)
{
    /// <summary>Its syntax.</summary>
    public string Form => string.Join(" | ", Forms.Split('|').Select(TextCatalogue.Fact));

    /// <summary>Its effect, with unit and range.</summary>
    public string Meaning => Wording.Get("Help." + Command);

    /// <summary>One line for a terminal.</summary>
    public override string ToString() => $"{TextCatalogue.Fact(Command)}  {Form}: {Meaning}";
}
