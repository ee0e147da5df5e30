using System.Security.Cryptography;
using System.Text;

namespace Engraver.Workbench.Files;

/// <summary>SHA-256 as 64 hexadecimal digits.</summary>
public static class ContentHash
{
    /// <summary>Hash of the bytes of a file; null if it cannot be read or is a stream, which can be read only once.</summary>
    public static string? OfFile(string path)
    {
        if (FileKind.IsStream(path)) return null;
        try
        {
            using var file = File.OpenRead(path);
            return Convert.ToHexStringLower(SHA256.HashData(file));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or ArgumentException)
        {
            return null;
        }
    }

    /// <summary>Hash of a text in UTF-8.</summary>
    public static string OfText(string text) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text)));
}
