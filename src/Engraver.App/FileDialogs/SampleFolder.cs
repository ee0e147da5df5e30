namespace Engraver.App.FileDialogs;

/// <summary>The sample drawings that come with the program.</summary>
internal static class SampleFolder
{
    private const int MaxLevelsAbove = 8;

    /// <summary>The folder <c>samples</c> beside the program or above it; null if it is not installed.</summary>
    public static string? Find()
    {
        var at = new DirectoryInfo(AppContext.BaseDirectory);
        for (var up = 0; up <= MaxLevelsAbove && at is not null; up++, at = at.Parent)
        {
            var folder = Path.Combine(at.FullName, "samples");
            if (File.Exists(Path.Combine(folder, "gasket.dxf"))) return folder;
        }

        return null;
    }
}
