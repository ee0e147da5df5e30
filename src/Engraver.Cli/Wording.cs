using Engraver.Core.Languages;

namespace Engraver.Cli;

/// <summary>The texts of this project from its <c>Texts.resx</c>, in the current language.</summary>
internal static class Wording
{
    private static readonly TextCatalogue s_texts = new(typeof(Wording).Assembly, "Engraver.Cli.Texts");

    public static string Get(string name) => s_texts.Get(name);

    public static string Get(string name, params object?[] facts) => s_texts.Get(name, facts);
}
