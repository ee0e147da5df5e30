using Engraver.Core.Languages;

namespace Engraver.Tools;

/// <summary>Every text of the tools that people read, from their <c>Texts.resx</c>, in the current language. Each program that compiles the tools embeds
/// the file.</summary>
internal static class Wording
{
    private static readonly TextCatalogue s_texts = new(typeof(Wording).Assembly, "Engraver.Tools.Texts");

    public static string Get(string name) => s_texts.Get(name);

    public static string Get(string name, params object?[] facts) => s_texts.Get(name, facts);
}
