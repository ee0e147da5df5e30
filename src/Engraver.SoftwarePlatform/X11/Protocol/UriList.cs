namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>text/uri-list (RFC 2483): one address per line, ended by CR LF; comments begin with #.</summary>
internal static class UriList
{
    /// <summary>The paths of the files on this machine; other addresses are left out.</summary>
    public static IReadOnlyList<string> LocalPaths(string text)
    {
        var paths = new List<string>();
        foreach (var line in text.Split(['\r', '\n', '\0'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries))
        {
            if (!line.StartsWith('#') && LocalPath(line) is { } path) paths.Add(path);
        }

        return paths;
    }

    /// <summary>Undoes escapes itself: <see cref="Uri"/> would take an unescaped # or ? for the end of the path.</summary>
    private static string? LocalPath(string address)
    {
        if (!address.StartsWith("file:", StringComparison.OrdinalIgnoreCase)) return null;
        var rest = address["file:".Length..];
        if (rest.StartsWith("//", StringComparison.Ordinal))
        {
            var slash = rest.IndexOf('/', 2);
            if (slash < 0 || !IsThisMachine(rest[2..slash])) return null;
            rest = rest[slash..];
        }

        return rest.StartsWith('/') ? Uri.UnescapeDataString(rest) : null;
    }

    private static bool IsThisMachine(string host) =>
        host.Length == 0 || host.Equals("localhost", StringComparison.OrdinalIgnoreCase) || host.Equals(Environment.MachineName, StringComparison.OrdinalIgnoreCase);
}
