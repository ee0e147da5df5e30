using System.Globalization;
using System.Resources;

namespace Engraver.App.Texts;

/// <summary>Every word the desktop shows, from <c>Texts.resx</c>; another language is another file beside it (<c>Texts.de.resx</c>). Numbers in them are always written with a point.</summary>
public static class Text
{
    private static readonly ResourceManager s_resources = new("Engraver.App.Texts.Texts", typeof(Text).Assembly);

    /// <exception cref="MissingManifestResourceException">No text has that name.</exception>
    public static string Get(string name) => Find(name) ?? throw new MissingManifestResourceException($"Texts.resx has no text '{name}'.");

    /// <summary>Null when no text has that name.</summary>
    public static string? Find(string name) => s_resources.GetString(name, CultureInfo.CurrentUICulture);

    /// <summary>A number with its noun: <c>NAME.One</c> for one, <c>NAME.Many</c> for every other number.</summary>
    public static string Count(string name, int count) => Get(name + (count == 1 ? ".One" : ".Many"), count);

    public static string Get(string name, params object?[] facts) => string.Format(CultureInfo.InvariantCulture, Get(name), facts);
}
