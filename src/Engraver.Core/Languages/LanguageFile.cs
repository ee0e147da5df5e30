using System.Collections.Frozen;
using System.Globalization;
using System.Reflection;
using System.Text.Json;

namespace Engraver.Core.Languages;

/// <summary>
/// The texts of a language other than English, from one file: <c>Languages/Texts/de.json</c> is German. It is a JSON object, <c>"PROJECT/NAME": "text"</c>,
/// with the names of each project's <c>Texts.resx</c>; <c>Keyword/NAME</c> is an option of a prompt, whose capitals are its short form; <c>Language/Name</c> is
/// the language's English name. Texts that a file lacks are English.
/// </summary>
public sealed class LanguageFile
{
    private const string Folder = "Engraver.Core.Languages.Texts.";
    private const string FileExtension = ".json";

    private static readonly FrozenDictionary<string, Lazy<LanguageFile>> s_files = Assembly.GetExecutingAssembly().GetManifestResourceNames()
        .Where(name => name.StartsWith(Folder, StringComparison.Ordinal) && name.EndsWith(FileExtension, StringComparison.Ordinal))
        .ToFrozenDictionary(name => name[Folder.Length..^FileExtension.Length], name => new Lazy<LanguageFile>(() => Load(name)), StringComparer.OrdinalIgnoreCase);

    private readonly FrozenDictionary<string, string> _texts;

    private LanguageFile(string code, FrozenDictionary<string, string> texts) => (Code, _texts) = (code, texts);

    /// <summary>The ISO 639 letters that name the file.</summary>
    public string Code { get; }

    /// <summary>The language's name in English, one word.</summary>
    public string Name => _texts["Language/Name"];

    /// <summary>Every text by its key.</summary>
    public IReadOnlyDictionary<string, string> Texts => _texts;

    /// <summary>Every built-in language except English, by its code.</summary>
    public static IEnumerable<LanguageFile> All => s_files.OrderBy(file => file.Key, StringComparer.Ordinal).Select(file => file.Value.Value);

    /// <summary>The file of a culture's language (that of <c>de-AT</c> is that of <c>de</c>); null where there is none, as for English.</summary>
    public static LanguageFile? For(CultureInfo culture)
    {
        ArgumentNullException.ThrowIfNull(culture);
        return For(culture.Name);
    }

    /// <summary>The file of a name such as <c>de</c>, <c>de-AT</c> or <c>de_DE.UTF-8</c>; null where there is none.</summary>
    public static LanguageFile? For(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        if (name.Length == 0) return null;
        var end = name.AsSpan().IndexOfAny('-', '_', '.');
        return s_files.TryGetValue(end < 0 ? name : name[..end], out var file) ? file.Value : null;
    }

    /// <summary>A text by its name; null when the file does not have it.</summary>
    public string? Find(string project, string name) => _texts.GetValueOrDefault($"{project}/{name}");

    private static LanguageFile Load(string resource)
    {
        using var stream = Assembly.GetExecutingAssembly().GetManifestResourceStream(resource)!;
        using var json = JsonDocument.Parse(stream);
        return new LanguageFile(resource[Folder.Length..^FileExtension.Length], json.RootElement.EnumerateObject().ToFrozenDictionary(text => text.Name, text => text.Value.GetString()!, StringComparer.Ordinal));
    }
}
