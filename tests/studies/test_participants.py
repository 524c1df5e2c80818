"""The table of participants, as spreadsheets and BIDS have it."""

import json

import pytest

from exoid.studies.dataset.participants import read_participants


def write(folder, text, name="participants.csv"):
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


def test_a_table_tells_who_the_people_are(tmp_path):
    text = "id,body_mass_kg,height_m,age_years,group,dose\nP01,77,1.8,30,a,0.5\nP02,,,,b,\n"
    people = read_participants(write(tmp_path, text)).participants
    first, second = people["P01"], people["P02"]
    assert (first.body_mass, first.height, first.age) == (77.0, 1.8, 30.0)
    assert first.more == {"group": "a", "dose": 0.5}
    assert (second.body_mass, second.height, second.age) == (None, None, None)
    assert second.more == {"group": "b", "dose": None}


@pytest.mark.parametrize(
    "header",
    [
        "Participant;Weight [g];Height (cm)",
        "subject_id;mass_g;stature_cm",
        "Patient;Körpergewicht (g);Größe (cm)",
        "Proband;Gewicht [g];Gro\u0308ße [cm]",  # as one system writes letters of two signs
    ],
)
def test_units_in_a_name_are_heeded_and_decimal_commas_read(tmp_path, header):
    table = read_participants(write(tmp_path, f"{header}\nP01;77000,0;180,5\n"))
    person = table.participants["P01"]
    assert person.body_mass == pytest.approx(77.0, rel=1e-12)  # rounding alone
    assert person.height == pytest.approx(1.805, rel=1e-12)


def test_the_units_of_bids_stand_in_the_file_beside(tmp_path):
    path = write(
        tmp_path,
        "participant_id\tage\tweight\theight\nsub-01\t40\t77\t180\nsub-02\tn/a\tn/a\tn/a\n",
        "participants.tsv",
    )
    (tmp_path / "participants.json").write_text(json.dumps({"height": {"Units": "cm"}}))
    people = read_participants(path).participants
    assert [*people] == ["01", "02"]
    assert (people["01"].body_mass, people["01"].height) == (77.0, pytest.approx(1.8))
    assert people["02"].age is None


@pytest.mark.parametrize("ending", ["parquet", "xlsx"])
def test_a_workbook_and_a_parquet_file_say_the_same_as_the_text(tmp_path, ending):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(
        {"id": [1, 2], "body_mass_kg": [77.5, None], "group": ["a", None], "code": ["007", "008"]}
    )
    path = tmp_path / f"participants.{ending}"
    frame.to_parquet(path) if ending == "parquet" else frame.to_excel(path, index=False)
    people = read_participants(path).participants
    assert people["1"].body_mass == 77.5
    assert people["2"].body_mass is None
    assert people["1"].more == {"group": "a", "code": "007"}
    assert people["2"].more["group"] is None


def test_a_cell_that_is_no_number_is_not_told_and_a_problem(tmp_path):
    table = read_participants(write(tmp_path, "id,body_mass_kg\nP01,seventy\nP02,70\n"))
    assert table.participants["P01"].body_mass is None
    assert table.participants["P02"].body_mass == 70.0
    (problem,) = table.problems
    assert problem.startswith("participants.csv: line 2, column body_mass_kg: 'seventy' is not a ")


def test_of_a_person_with_two_body_masses_neither_is_told(tmp_path):
    table = read_participants(write(tmp_path, "id,body_mass_kg,height_m\nP1,70,1.8\nP1,77,1.8\n"))
    person = table.participants["P1"]
    assert (person.body_mass, person.height) == (None, 1.8)
    (problem,) = table.problems
    assert "line 3: P1 stands there twice, with body_mass 70.0 and 77.0" in problem


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "name,mass\nP01,70\n",
            "that says who it is participant_id. It holds: name, mass",
        ),
        ("", "is empty"),
        ("id,group\nP01,a,b\n", "line 2 has 3 cells, but the header names 2"),
        ("id,id\nP01,P02\n", "column id is there twice"),
        ('id,group\nP01,"a\n', "line 2: a quote"),
        ("id\0,group\n", "holds binary data"),
    ],
)
def test_what_is_no_table_of_participants_is_refused_in_a_line(tmp_path, text, said):
    with pytest.raises(ValueError, match=r"participants\.csv: ") as refused:
        read_participants(write(tmp_path, text))
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)
