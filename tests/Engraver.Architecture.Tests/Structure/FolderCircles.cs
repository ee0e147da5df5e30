using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>Folders that name each other's types, directly or through others: a circle. Folders are compared with their neighbours in the same parent, at every
/// level below src; files in the parent itself are ignored. Dependencies between projects have a separate test.</summary>
/// <param name="Parent">The folder that contains them, relative to the root: src/Engraver.Core.</param>
/// <param name="Rooms">Their names, in order.</param>
public sealed record FolderCircle(string Parent, IReadOnlyList<string> Rooms)
{
    public override string ToString() => $"{Parent}: {string.Join(' ', Rooms)}";
}

/// <summary>Finds circles by names: a type that is declared in one folder only, named in the code of another folder.</summary>
public static partial class FolderCircles
{
    public static IReadOnlyList<FolderCircle> Find(IReadOnlyList<SourceFile> files) =>
        [.. files.SelectMany(file => Parents(file.Name)).Distinct().Order(StringComparer.Ordinal).SelectMany(parent => In(parent, files))];

    private static IEnumerable<string> Parents(string name)
    {
        for (var slash = name.LastIndexOf('/'); slash > 0 && name.AsSpan(0, slash).Contains('/'); slash = name.LastIndexOf('/', slash - 1)) yield return name[..slash];
    }

    private static IEnumerable<FolderCircle> In(string parent, IReadOnlyList<SourceFile> files)
    {
        var rooms = files.Where(file => RoomOf(parent, file.Name) is not null).GroupBy(file => RoomOf(parent, file.Name)!)
            .ToDictionary(room => room.Key, room => string.Join('\n', room.Select(file => CSharpText.Parse(file.Text).Code)));
        if (rooms.Count < 2) return [];
        var arrows = Arrows(rooms);
        var reach = rooms.Keys.ToDictionary(room => room, room => Reachable(room, arrows));
        return rooms.Keys.Where(room => reach[room].Contains(room))
            .Select(room => new FolderCircle(parent, [.. reach[room].Where(other => reach[other].Contains(room)).Order(StringComparer.Ordinal)]))
            .DistinctBy(circle => circle.ToString());
    }

    private static string? RoomOf(string parent, string file)
    {
        if (!file.StartsWith(parent + "/", StringComparison.Ordinal)) return null;
        var rest = file[(parent.Length + 1)..];
        return rest.IndexOf('/') is > 0 and var slash ? rest[..slash] : null;
    }

    private static Dictionary<string, HashSet<string>> Arrows(Dictionary<string, string> rooms)
    {
        var homes = rooms.SelectMany(room => Declaration().Matches(room.Value).Select(found => (Type: found.Groups["name"].Value, Room: room.Key)))
            .GroupBy(one => one.Type).Where(type => type.Select(one => one.Room).Distinct().Count() == 1).ToDictionary(type => type.Key, type => type.First().Room);
        return rooms.ToDictionary(room => room.Key, room => Word().Matches(room.Value).Select(word => homes.GetValueOrDefault(word.Value)).OfType<string>().Where(home => home != room.Key).ToHashSet());
    }

    private static HashSet<string> Reachable(string from, Dictionary<string, HashSet<string>> arrows)
    {
        var seen = new HashSet<string>();
        var open = new Stack<string>(arrows[from]);
        while (open.TryPop(out var room))
        {
            if (!seen.Add(room)) continue;
            foreach (var next in arrows[room]) open.Push(next);
        }

        return seen;
    }

    [GeneratedRegex(@"\b(?:class|struct|record|interface|enum)\s+(?:struct\s+|class\s+)?(?<name>[A-Z]\w+)")]
    private static partial Regex Declaration();

    [GeneratedRegex(@"\b[A-Z]\w+")]
    private static partial Regex Word();
}
