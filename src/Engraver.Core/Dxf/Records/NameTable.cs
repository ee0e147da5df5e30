using System.Diagnostics.CodeAnalysis;

namespace Engraver.Core.Dxf.Records;

/// <summary>Assigns small numbers to names. A name is looked up by its bytes; only a new spelling is decoded, and spellings that differ by case share a
/// number.</summary>
internal sealed class NameTable(Func<ReadOnlySpan<byte>, string> decode)
{
    private readonly Dictionary<byte[], int> _byBytes = new(BytesComparer.Instance);
    private readonly Dictionary<string, int> _byName = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<string> _names = [];

    /// <summary>Recent spellings, indexed by a few of their bits: most drawings use a few layers in turn.</summary>
    private readonly (byte[] Name, int Id)[] _recent = [.. Enumerable.Repeat((Array.Empty<byte>(), -1), 16)];

    public int Count => _names.Count;

    /// <summary>The name as first spelled.</summary>
    public string this[int id] => _names[id];

    /// <summary>The names in the order of their numbers.</summary>
    public IReadOnlyList<string> ToList() => _names;

    public int IdOf(ReadOnlySpan<byte> bytes)
    {
        ref var recent = ref _recent[bytes.IsEmpty ? 0 : (bytes.Length + bytes[^1]) & 15];
        if (recent.Id >= 0 && bytes.SequenceEqual(recent.Name)) return recent.Id;
        var name = bytes.Trim(" \t"u8);
        var lookup = _byBytes.GetAlternateLookup<ReadOnlySpan<byte>>();
        if (!lookup.TryGetValue(name, out var id))
        {
            id = IdOf(decode(name));
            lookup[name] = id;
        }

        lookup.TryGetValue(name, out var kept, out _);
        if (name.Length == bytes.Length) recent = (kept!, id);
        return id;
    }

    public int IdOf(string name)
    {
        if (_byName.TryGetValue(name, out var id)) return id;
        _byName.Add(name, _names.Count);
        _names.Add(name);
        return _names.Count - 1;
    }

    private sealed class BytesComparer : IEqualityComparer<byte[]>, IAlternateEqualityComparer<ReadOnlySpan<byte>, byte[]>
    {
        public static BytesComparer Instance { get; } = new();

        public bool Equals(byte[]? x, byte[]? y) => x.AsSpan().SequenceEqual(y);

        public bool Equals(ReadOnlySpan<byte> alternate, byte[] other) => alternate.SequenceEqual(other);

        public int GetHashCode([DisallowNull] byte[] obj) => GetHashCode(obj.AsSpan());

        /// <summary>Seeded for each process, so that a file cannot be made to cause collisions.</summary>
        public int GetHashCode(ReadOnlySpan<byte> alternate)
        {
            var hash = new HashCode();
            hash.AddBytes(alternate);
            return hash.ToHashCode();
        }

        public byte[] Create(ReadOnlySpan<byte> alternate) => alternate.ToArray();
    }
}
