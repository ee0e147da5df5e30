using Engraver.Core.Languages;

namespace Engraver.Cli;

/// <summary>Every text of this project that people read, from its <c>Texts.resx</c>, in the language of now.</summary>
internal static class Wording
{
    private static readonly TextCatalogue s_texts = new(typeof(Wording).Assembly, "Engraver.Cli.Texts");

    public static string Get(string name) => s_texts.Get(name);

    public static string Get(string name, params object?[] facts) => s_texts.Get(name, facts);
}
