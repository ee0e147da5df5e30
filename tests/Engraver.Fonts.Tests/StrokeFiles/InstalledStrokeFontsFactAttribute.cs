namespace Engraver.Fonts.Tests.StrokeFiles;

/// <summary>A test that uses every LFF font of Debian's librecad-data and every JHF font of hershey-fonts-data; skipped if one of them is not installed.
/// ./test installs them if permitted.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class InstalledStrokeFontsFactAttribute : FactAttribute
{
    public const string LibreCadFolder = "/usr/share/librecad/fonts", HersheyFolder = "/usr/share/hershey-fonts";

    public InstalledStrokeFontsFactAttribute()
    {
        if (!Directory.Exists(LibreCadFolder)) Skip = "librecad-data is not installed.";
        else if (!Directory.Exists(HersheyFolder)) Skip = "hershey-fonts-data is not installed.";
    }
}
