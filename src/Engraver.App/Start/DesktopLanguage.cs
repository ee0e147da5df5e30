using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Core.Languages;

namespace Engraver.App.Start;

/// <summary>The language of the desktop: that of its command line, otherwise that of LANGUAGE, otherwise that of the system, otherwise English.</summary>
internal sealed partial class DesktopLanguage : IDisposable
{
    private const int LongestLocaleName = 85;

    private static readonly string[] s_variables = ["LC_ALL", "LC_MESSAGES", "LANG"];

    private readonly (CultureInfo Now, CultureInfo? Default) _previous = (CultureInfo.CurrentUICulture, CultureInfo.DefaultThreadCurrentUICulture);

    private DesktopLanguage(CultureInfo culture) => CultureInfo.CurrentUICulture = CultureInfo.DefaultThreadCurrentUICulture = culture;

    /// <summary>All threads use it until this is disposed.</summary>
    public static DesktopLanguage Apply(string name) => new(name.Length == 0 ? CultureInfo.InvariantCulture : new CultureInfo(name));

    /// <summary>The name of the culture; empty is English.</summary>
    /// <param name="asked">From the command line, which has precedence over the settings; null for none.</param>
    /// <param name="kept">From the settings; null is the language of the system.</param>
    /// <param name="system">Names of the system's languages, in order of precedence (<c>de_DE.UTF-8</c>).</param>
    public static string Choose(string? asked, string? kept, IEnumerable<string?> system)
    {
        if (asked is not null && asked.Equals(PseudoLanguage.CultureName, StringComparison.OrdinalIgnoreCase)) return asked;
        var name = asked ?? kept ?? system.FirstOrDefault(one => !string.IsNullOrEmpty(one)) ?? "";
        return LanguageFile.For(name)?.Code ?? "";
    }

    /// <summary>The language of the system: on Windows that of the user's regional settings, elsewhere the POSIX variables in their order.</summary>
    public static IEnumerable<string?> OfSystem()
    {
        if (!OperatingSystem.IsWindows()) return s_variables.Select(Environment.GetEnvironmentVariable);
        return [WindowsName()];
    }

    public void Dispose() => (CultureInfo.CurrentUICulture, CultureInfo.DefaultThreadCurrentUICulture) = _previous;

    /// <summary>Null if Windows returns none.</summary>
    private static unsafe string? WindowsName()
    {
        var name = stackalloc char[LongestLocaleName];
        var length = GetUserDefaultLocaleName((ushort*)name, LongestLocaleName); // including the terminating zero
        return length > 1 ? new string(name, 0, length - 1) : null;
    }

    [LibraryImport("kernel32.dll")]
    private static unsafe partial int GetUserDefaultLocaleName(ushort* name, int size);
}
