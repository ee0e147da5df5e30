using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Core.Languages;

namespace Engraver.App.Start;

/// <summary>In which language the desktop speaks: that of its command line, else that of LANGUAGE, else that of the system, else English.</summary>
internal sealed partial class SpokenLanguage : IDisposable
{
    private const int LongestLocaleName = 85;

    private static readonly string[] s_variables = ["LC_ALL", "LC_MESSAGES", "LANG"];

    private readonly (CultureInfo Now, CultureInfo? Default) _before = (CultureInfo.CurrentUICulture, CultureInfo.DefaultThreadCurrentUICulture);

    private SpokenLanguage(CultureInfo culture) => CultureInfo.CurrentUICulture = CultureInfo.DefaultThreadCurrentUICulture = culture;

    /// <summary>Every thread speaks it until this is disposed.</summary>
    public static SpokenLanguage Speak(string name) => new(name.Length == 0 ? CultureInfo.InvariantCulture : new CultureInfo(name));

    /// <summary>The name of the culture to speak; empty is English.</summary>
    /// <param name="asked">Of the command line: spoken whatever the settings say; null when nothing was asked.</param>
    /// <param name="kept">Of the settings; null is that of the system.</param>
    /// <param name="system">Names of the system's languages, the first that counts first (<c>de_DE.UTF-8</c>).</param>
    public static string Choose(string? asked, string? kept, IEnumerable<string?> system)
    {
        if (asked is not null && asked.Equals(PseudoLanguage.CultureName, StringComparison.OrdinalIgnoreCase)) return asked;
        var name = asked ?? kept ?? system.FirstOrDefault(one => !string.IsNullOrEmpty(one)) ?? "";
        return LanguageFile.For(name)?.Code ?? "";
    }

    /// <summary>What the system says: on Windows the language of the user's regional settings, elsewhere the variables of POSIX in their order.</summary>
    public static IEnumerable<string?> OfSystem()
    {
        if (!OperatingSystem.IsWindows()) return s_variables.Select(Environment.GetEnvironmentVariable);
        return [WindowsName()];
    }

    public void Dispose() => (CultureInfo.CurrentUICulture, CultureInfo.DefaultThreadCurrentUICulture) = _before;

    /// <summary>Null when Windows tells none.</summary>
    private static unsafe string? WindowsName()
    {
        var name = stackalloc char[LongestLocaleName];
        var length = GetUserDefaultLocaleName((ushort*)name, LongestLocaleName); // with the zero at its end
        return length > 1 ? new string(name, 0, length - 1) : null;
    }

    [LibraryImport("kernel32.dll")]
    private static unsafe partial int GetUserDefaultLocaleName(ushort* name, int size);
}
