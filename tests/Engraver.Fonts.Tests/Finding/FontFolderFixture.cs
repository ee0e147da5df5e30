using Engraver.TestKit;

namespace Engraver.Fonts.Tests.Finding;

/// <summary>Folders of fonts that the test writes; deleted with it.</summary>
internal sealed class FontFolderFixture : IDisposable
{
    private readonly string _root = Directory.CreateTempSubdirectory("fonts").FullName;

    public string Path(string name) => System.IO.Path.Combine(_root, name);

    public string Folder(string name) => Directory.CreateDirectory(Path(name)).FullName;

    public string Write(string name, byte[] data)
    {
        Directory.CreateDirectory(System.IO.Path.GetDirectoryName(Path(name))!);
        File.WriteAllBytes(Path(name), data);
        return Path(name);
    }

    public string Write(string name, FontBuilder font) => Write(name, font.Build());

    public void Dispose() => Directory.Delete(_root, recursive: true);
}
