using System.Text.Json;

namespace Engraver.Core.Languages;

/// <summary>Why the operating system or a library refused, in this program's own words: part of a sentence that names the file or the address, without a full
/// stop.</summary>
/// <remarks>The texts of the runtime name its own types and repeat the path, and are English in every language. An exception thrown by this program keeps its
/// message.</remarks>
public static class SystemErrorText
{
    /// <summary>HResult of an <see cref="IOException"/> without a cause: thrown by this program with its own message.</summary>
    private const int Unspecified = unchecked((int)0x80131620);

    /// <param name="failure">Failure of a file or a device, or of reading JSON.</param>
    public static string FromException(Exception failure)
    {
        ArgumentNullException.ThrowIfNull(failure);
        if (failure is JsonException { LineNumber: { } line } unreadable) return unreadable.Path is { Length: > 2 } path ? Wording.Get("SystemErrorText.JsonValue", line + 1, path[2..]) : Wording.Get("SystemErrorText.Json", line + 1);
        return Key(failure) is { } key ? Wording.Get(key) : TextCatalogue.Fact(failure.Message.TrimEnd('.'));
    }

    /// <summary>The same reason after the path that the runtime's message names, for a sentence without its own name of the file.</summary>
    public static string WithPath(Exception failure)
    {
        ArgumentNullException.ThrowIfNull(failure);
        return Key(failure) is not null && failure.Message.Split('\'') is [_, { Length: > 0 } path, _] ? Wording.Get("SystemErrorText.OfPath", path, FromException(failure)) : FromException(failure);
    }

    /// <summary>Name of the text; null for a failure that has none.</summary>
    private static string? Key(Exception failure) => failure switch
    {
        FileNotFoundException => "SystemErrorText.NoFile",
        DirectoryNotFoundException => "SystemErrorText.NoFolder",
        PathTooLongException => "SystemErrorText.PathTooLong",
        UnauthorizedAccessException => "SystemErrorText.AccessDenied",
        IOException { HResult: not Unspecified } => FromCode(failure.HResult),
        _ => null,
    };

    /// <summary>Codes of Windows (the low 16 bits of the HResult) and of Unix (errno).</summary>
    private static string? FromCode(int code) => (code & 0xFFFF0000) == 0x80070000
        ? (code & 0xFFFF) switch { 39 or 112 => "SystemErrorText.DiskFull", 32 or 33 => "SystemErrorText.InUse", 19 => "SystemErrorText.ReadOnly", 80 or 183 => "SystemErrorText.Exists", _ => null }
        : code switch { 28 or 122 => "SystemErrorText.DiskFull", 11 or 16 or 26 => "SystemErrorText.InUse", 30 => "SystemErrorText.ReadOnly", 17 => "SystemErrorText.Exists", 5 => "SystemErrorText.DeviceFailed", 32 => "SystemErrorText.ReaderEnded", _ => null };
}
