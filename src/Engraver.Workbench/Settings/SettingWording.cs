using System.Text.RegularExpressions;
using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;

namespace Engraver.Workbench.Settings;

/// <summary>Puts advice into the words of where it is read: findings name settings by their keys, <c>[max-error]</c>, and here those become options of the
/// console or commands of the desktop. <c>[+key]</c> and <c>[-key]</c> are a switch given and not given.</summary>
public static partial class SettingWording
{
    /// <summary>Keys that stand for more than the name of a setting: a setting with a value, or a command that shows something.</summary>
    private static readonly Dictionary<string, (string Console, string Desktop)> s_phrases = new(StringComparer.Ordinal)
    {
        ["units-mm"] = ($"{SettingTable.Units.Option} mm", $"{SettingTable.Units.Command} 4"),
        ["units-inch"] = ($"{SettingTable.Units.Option} inch", $"{SettingTable.Units.Command} 1"),
        ["look"] = (Verb("info"), "CHECK"),
        ["certify"] = (Verb("certify"), "CERTIFY"),
        ["connect"] = ("--connect", "CNCCONNECT"),
        ["zero"] = (Verb("zero"), "CNCZERO"),
        ["home"] = (Verb("home"), "CNCHOME"),
        ["motors"] = (Verb("motors"), "CNCMOTORS"),
        ["origin-here"] = ("--origin here", "CNCZERO Point"),
    };

    /// <summary>For the console: <c>--max-error</c>.</summary>
    public static Diagnostic OnConsole(Diagnostic finding) => Translate(finding, Console);

    /// <summary>For the command line of the desktop: <c>CNCMAXERR</c>.</summary>
    public static Diagnostic AtCommandLine(Diagnostic finding) => Translate(finding, Desktop);

    /// <summary>A text of the console with its settings named as options.</summary>
    public static string OnConsole(string text) => Key().Replace(text, key => Console(key.Groups["sign"].Value, key.Groups["key"].Value));

    /// <summary>A text of the desktop with its settings named as commands.</summary>
    public static string AtCommandLine(string text) => Key().Replace(text, key => Desktop(key.Groups["sign"].Value, key.Groups["key"].Value));

    private static string Verb(string name) => $"engraver {name}";

    private static Diagnostic Translate(Diagnostic finding, Func<string, string, string> spell)
    {
        ArgumentNullException.ThrowIfNull(finding);
        var advice = Key().Replace(finding.Advice, key => spell(key.Groups["sign"].Value, key.Groups["key"].Value));
        return advice == finding.Advice ? finding : finding with { Advice = advice };
    }

    private static string Console(string sign, string key)
    {
        var flag = s_phrases.TryGetValue(key, out var phrase) ? phrase.Console : Find(key).Option ?? Find(key).Name;
        return sign switch { "+" => Wording.Get("Advice.With", flag), "-" => Wording.Get("Advice.Without", flag), _ => TextCatalogue.Fact(flag) };
    }

    private static string Desktop(string sign, string key)
    {
        var command = s_phrases.TryGetValue(key, out var phrase) ? phrase.Desktop : Find(key).Command;
        return sign switch { "+" => Wording.Get("Advice.With", command + " 1"), "-" => Wording.Get("Advice.With", command + " 0"), _ => key == SettingTable.Cut.Key ? Wording.Get("Advice.CutAtOpening", command) : TextCatalogue.Fact(command) };
    }

    private static Setting Find(string key) => SettingTable.Find(key) ?? throw new ArgumentException(key, nameof(key));

    [GeneratedRegex(@"\[(?<sign>[-+]?)(?<key>[a-z][a-z-]+)\]", RegexOptions.CultureInvariant)]
    private static partial Regex Key();
}
