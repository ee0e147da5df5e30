namespace Engraver.Core.SecondOpinions;

/// <summary>The records of a file's BLOCKS and ENTITIES sections, one after the other; only the one under way is in memory.</summary>
internal static class SecondRecords
{
    /// <param name="file">Gone through once for each enumeration.</param>
    /// <param name="wanted">Name of the section. Its end comes as a record ENDSEC.</param>
    public static IEnumerable<SecondRecord> In(SecondFile file, string wanted)
    {
        var record = new SecondRecord(file, "");
        var inside = false;
        foreach (var tag in file.Tags)
        {
            if (tag.Code != 0)
            {
                if (inside || record.Type == "SECTION") record.Tags.Add(tag);
                continue;
            }

            if (inside) yield return record;
            if (record.Type == "SECTION") inside = record.Tags is [{ Code: 2 }, ..] && record.Text(2).Equals(wanted, StringComparison.OrdinalIgnoreCase);
            record = new SecondRecord(file, file.Text(tag).ToUpperInvariant());
            if (!inside || record.Type is not ("ENDSEC" or "EOF" or "SECTION")) continue;
            inside = false;
            yield return new SecondRecord(file, "ENDSEC");
        }

        if (inside) yield return record;
    }
}
