namespace Engraver.App.Tests.Start;

/// <summary>A folder that is deleted after the test.</summary>
internal sealed class TemporaryDesktopFolder : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("desktop-");

    public string Path => _folder.FullName;

    public void Dispose() => _folder.Delete(recursive: true);
}
